/**
 * The document: what a {@code .jen} file says, as immutable records.
 *
 * <p>Angles are in degrees and lengths in scene units, exactly as written in the file. Every
 * constructor rejects values outside the ranges of {@link lightning.scene.SceneLimits} with an
 * {@link java.lang.IllegalArgumentException} whose message names the property, what was expected
 * and what was found; whoever holds a scene need not check again.
 *
 * <pre>{@code
 * Light key = scene.light("key").orElseThrow();
 * Scene dimmer = scene.withLight(key.withIntensity(0.5));
 * }</pre>
 */
package lightning.scene;
