// What the bundler makes of files that are no modules.
declare module "*.css" {
  const text: string;
  export default text;
}
declare const WORKER: string; // the text of a script
interface Element {
  figure?: any;
  explorer?: any;
}
