/**
 * Ray intersection with triangle meshes in local space, by a BVH or by testing every triangle, and surface properties at the
 * hit.
 */
@NullMarked
package lightning.render.trace.mesh;

import org.jspecify.annotations.NullMarked;
