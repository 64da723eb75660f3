/** What build.mjs brings in from other files. */
declare module "text:*" {
  const text: string;
  export default text;
}
declare module "worker:*" {
  const program: string;
  export default program;
}
declare module "docs:mistakes" {
  const catalogue: Record<string, { title: string; lesson: string }>;
  export default catalogue;
}
declare module "scenarios:offered" {
  const offered: Record<string, string>;
  export default offered;
}
