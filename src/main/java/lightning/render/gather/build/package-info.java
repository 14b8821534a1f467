/** Builds the paths of a scene, or repeats those of a scene before an edit. Entry point: {@link lightning.render.gather.build.GatherBuilder}. */
@NullMarked
package lightning.render.gather.build;

import org.jspecify.annotations.NullMarked;
