/**
 * Ray intersection with triangle meshes in local space, by a BVH or by testing every triangle, and surface properties at the
 * hit.
 */
package lightning.render.trace.mesh;
