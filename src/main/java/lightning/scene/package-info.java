/**
 * Scene description: the content of a {@code .jen} file as immutable records.
 * Nothing here traces, reads a file or knows a window.
 *
 * <p>Angles are in degrees and lengths in scene units, exactly as written in the file. Every constructor rejects values outside the ranges
 * of {@link lightning.scene.value.SceneLimits} with an {@link java.lang.IllegalArgumentException} whose message names the property, the expected
 * and the actual value, so users of a scene need no further checks.
 *
 * <pre>{@code
 * Light key = scene.light("key").orElseThrow();
 * Scene dimmer = scene.withLight(key.withIntensity(0.5));
 * }</pre>
 */
@NullMarked
package lightning.scene;

import org.jspecify.annotations.NullMarked;
