/**
 * How fast rays are traced against one mesh, without a scene around it: generated meshes, sets of rays, our own search, and Embree's
 * beside it where it is installed.
 */
package lightning.bench.mesh;
