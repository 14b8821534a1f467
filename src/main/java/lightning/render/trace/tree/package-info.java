/**
 * BVH over the primitives, built by {@link lightning.render.trace.tree.BvhBuilder} and traversed by single rays, beams, and
 * light positions. The BVH only rejects; the primitives decide hits.
 */
@NullMarked
package lightning.render.trace.tree;

import org.jspecify.annotations.NullMarked;
