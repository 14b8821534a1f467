/**
 * Controls of the property editor for numbers, vectors and colors. They depend on values and settings, not on a document.
 *
 * <pre>{@code
 * var angle = new ArrowWidget("Angle", "angle", NumberSetting.of("angle", new StepRange(1, 0, 180), (v, gesture) -> Optional.empty()));
 * angle.show(30);
 * }</pre>
 *
 * <p>A widget shows the last value that it was given. Edits go to its {@link lightning.editor.window.widget.NumberSetting}, whose owner
 * shows the new value in turn. A refused edit is marked with its reason and changes nothing. All edits of a drag carry the same gesture,
 * an object compared by identity. Escape during a drag restores the initial value.
 */
@NullMarked
package lightning.editor.window.widget;

import org.jspecify.annotations.NullMarked;
