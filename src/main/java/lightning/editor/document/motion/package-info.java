/**
 * The shot of one light that an animation records: its keys, its file, and its pictures (paper §3.7).
 */
package lightning.editor.document.motion;
