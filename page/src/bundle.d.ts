// What the bundler makes of files that are no modules.
declare module "*.css" {
  const text: string;
  export default text;
}
declare module "worker:*" {
  const source: string;
  export default source;
}
interface Element {
  figure?: any;
  explorer?: any;
}
