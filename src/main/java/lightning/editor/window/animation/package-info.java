/**
 * The animation of one light: record, play, scrub, export.
 */
package lightning.editor.window.animation;
