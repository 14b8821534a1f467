/**
 * Open document of the editor: edits, selection, history, cameras, gizmos, motion paths and recovery. Independent of the UI toolkit.
 * Menus and panes belong to {@code editor}.
 *
 * <pre>{@code
 * OpenDocument document = OpenDocument.open(Path.of("scenes/bird.jen"));
 * document.apply(LightEdits.edit(document.scene(), "lamp", light -> light.withIntensity(1.2)));
 * document.undo();
 * }</pre>
 *
 * <p>An edit is a function from a scene to a {@link lightning.document.EditOutcome}: another scene, or the reason why there is none.
 * Pixels count from the left and from the top of a canvas. Angles are in degrees unless a name says radians. Only {@link
 * lightning.document.loop.RenderLoop} and {@link lightning.document.Autosave} are thread-safe.
 */
@NullMarked
package lightning.document;

import org.jspecify.annotations.NullMarked;
