/**
 * From a scene to a picture: the options of renderers ({@link lightning.render.RenderOptions}).
 * Files, undo and windows belong elsewhere: a renderer gets a scene and returns a film.
 */
@NullMarked
package lightning.render;

import org.jspecify.annotations.NullMarked;
