/** Light mixer with a strip for each light and light group of the scene. */
@NullMarked
package lightning.editor.window.mixer;

import org.jspecify.annotations.NullMarked;
