/** Cues, which are saved looks of a scene with images, and light rigs as files. */
package lightning.editor.document.cue;
