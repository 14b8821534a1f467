/** Recorded movement of one light: keyframes, file format and image export (paper §3.7). */
package lightning.editor.document.motion;
