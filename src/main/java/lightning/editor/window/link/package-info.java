/** Table of the links and gains between lights and objects. */
package lightning.editor.window.link;
