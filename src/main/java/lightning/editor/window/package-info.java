/**
 * The editor's window: JavaFX panes over what {@link lightning.editor.document} holds. The only package that knows JavaFX.
 *
 * <pre>{@code
 * Optional<String> obstacle = WindowToolkit.start();
 * if (obstacle.isEmpty()) {
 *     LightningApp.open(List.of("scenes/bird.jen"));
 * }
 * }</pre>
 */
package lightning.editor.window;
