/**
 * Cues: how a scene was lit, kept beside it with a picture; and light rigs as files.
 */
package lightning.editor.document.cue;
