/**
 * Relighting: finds what an edit changed and recomputes only that (paper §4).
 *
 * <p>The {@link lightning.render.relight.plan.Dispatcher} compares the scene rendered last with the target scene. It plans the least
 * update for each light's layer and for the rows of edited materials; callers set no flags. The
 * {@link lightning.render.relight.Renderer} applies the plan to the tiles of the pixel cache.
 *
 * <pre>{@code
 * try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
 *     renderer.render(scene, Progress.NONE);                  // the first pass
 *     UpdateResult update = renderer.render(edited, Progress.NONE); // only what changed
 *     Film picture = renderer.film();
 * }
 * }</pre>
 */
@NullMarked
package lightning.render.relight;

import org.jspecify.annotations.NullMarked;
