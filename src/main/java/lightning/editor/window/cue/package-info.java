/** Gallery of saved looks (cues), which can be applied, compared and blended. */
package lightning.editor.window.cue;
