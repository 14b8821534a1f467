/**
 * The controls of the property editor: numbers, vectors and colors that a light is lit by. They know values and where
 * edits go, and no document.
 *
 * <pre>{@code
 * var angle = new ArrowWidget("Angle", "angle", NumberSetting.of("angle", new StepRange(1, 0, 180), (v, gesture) -> Optional.empty()));
 * angle.show(30);
 * }</pre>
 *
 * <p>A widget shows what it was given last; an edit goes to its {@link lightning.editor.window.widget.NumberSetting}, which shows the new
 * value in turn. An edit that is refused is marked with the reason and changes nothing. All edits of one drag carry the
 * same gesture, an object told by identity; Escape during the drag brings back where it began.
 */
package lightning.editor.window.widget;
