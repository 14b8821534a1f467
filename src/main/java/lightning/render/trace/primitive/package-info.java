/**
 * What rays can meet: the primitives of a scene as plain columns in render space, and the surface where one of them is met.
 *
 * <p>A primitive is a canonical {@link lightning.render.trace.solid solid} or a {@link lightning.render.trace.mesh mesh}, with its map and the shape
 * that it is a part of. Errors that placing it may have made are bounded here, for rays that begin or end on it.
 */
package lightning.render.trace.primitive;
