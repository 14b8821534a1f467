/**
 * The way of a light across the frames of an animation: recorded, kept as text, and written as pictures (paper §3.7).
 */
package lightning.editor.document.motion;
