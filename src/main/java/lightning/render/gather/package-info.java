/**
 * Paths of gathered light and of blurred reflections: where light is gathered, from where it comes, and the weights of these points in rows.
 * They depend on shapes and the camera alone, so an edit of lights keeps them. Entry points: {@link lightning.render.gather.GatherStructure}
 * and {@link lightning.render.gather.RowWeigher}.
 */
@NullMarked
package lightning.render.gather;

import org.jspecify.annotations.NullMarked;
