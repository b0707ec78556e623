// Angles in degrees and in radians.

export const RAD = Math.PI / 180; // of a degree
export const DEG = 180 / Math.PI; // of a radian
