// Converts between degrees and radians.

export const RAD = Math.PI / 180; // radians in one degree
export const DEG = 180 / Math.PI; // degrees in one radian
