/**
 * Primitives of a scene as columns in render space, and surface data at a ray's hit.
 *
 * <p>A primitive is a canonical {@link lightning.render.trace.solid solid} or a {@link lightning.render.trace.mesh mesh}, with
 * its transform and the shape that it belongs to. This package also bounds the errors of transforms, for rays that start or end
 * on a primitive.
 */
@NullMarked
package lightning.render.trace.primitive;

import org.jspecify.annotations.NullMarked;
