/** Descriptors of attributes: name, kind of value, range, comparison and format. */
package lightning.scene.attribute;
