// Types of the files that the bundler imports as text.
declare module "*.css" {
  const text: string;
  export default text;
}
declare const WORKER: string; // the text of a script
interface Element {
  figure?: any;
  explorer?: any;
}
