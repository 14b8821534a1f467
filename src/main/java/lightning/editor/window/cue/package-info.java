/**
 * The gallery of cues: how a scene was lit, to be restored, compared and blended.
 */
package lightning.editor.window.cue;
