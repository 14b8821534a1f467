/**
 * The editor's windows: JavaFX views of the model in {@link lightning.document}. Only this package and its sub-packages use JavaFX.
 * Anything that works without a window belongs to {@code document} or {@code editor}.
 *
 * <pre>{@code
 * Optional<String> reason = WindowToolkit.start();
 * if (reason.isEmpty()) {
 *     LightningApp.open(List.of("scenes/bird.jen"));
 * }
 * }</pre>
 */
@NullMarked
package lightning.editor.window;

import org.jspecify.annotations.NullMarked;
