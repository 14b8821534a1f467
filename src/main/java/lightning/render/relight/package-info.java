/**
 * Relighting: finds what an edit changed and recomputes only that (paper §4).
 *
 * <p>The {@link lightning.render.relight.plan.Dispatcher} compares two scenes, the one rendered last and the one
 * wanted, and finds the least update for each light's layer and for the rows of edited materials; nobody sets flags. The
 * {@link lightning.render.relight.Renderer} runs it over the tiles of the pixel cache.
 *
 * <pre>{@code
 * try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
 *     renderer.render(scene, Progress.NONE);                  // the first pass
 *     UpdateResult update = renderer.render(edited, Progress.NONE); // only what changed
 *     Film picture = renderer.film();
 * }
 * }</pre>
 */
package lightning.render.relight;
