/**
 * The tree of boxes over the primitives: built by {@link lightning.render.trace.tree.BvhBuilder}, gone through by single rays, by the beam of a
 * tile's rays, and by the points where ways to lights end. It only rejects; what it lets through is asked of the primitive.
 */
package lightning.render.trace.tree;
