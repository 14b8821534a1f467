/**
 * The open document as an editor sees it: edits, selection, history, cameras, gizmos, motion paths, recovery, and the
 * loop that renders. Knows no toolkit.
 *
 * <pre>{@code
 * OpenDocument document = OpenDocument.open(Path.of("scenes/bird.jen"));
 * document.apply(LightEdits.edit(document.scene(), "lamp", light -> light.withIntensity(1.2)));
 * document.undo();
 * }</pre>
 *
 * <p>An edit is a function from a scene to a {@link lightning.editor.document.EditOutcome}: another scene, or the reason why there is
 * none. Pixels count from the left and from the top of a canvas; angles are in degrees unless a name says radians.
 * Nothing here is safe for several threads but {@link lightning.editor.loop.RenderLoop} and {@link lightning.editor.document.Autosave}.
 */
package lightning.editor.document;
