/**
 * Vectors, colors and transforms in double precision: the numbers that everything else is made of.
 *
 * <p>All types are immutable. Angles are in radians here; the scene file speaks degrees. No method
 * uses fused multiply-add, so that each result is the same on every machine and at every stage of
 * compilation.
 */
package lightning.base.math;
