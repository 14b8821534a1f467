/** Table of the links and gains between lights and objects. */
@NullMarked
package lightning.editor.window.link;

import org.jspecify.annotations.NullMarked;
