/** Tests of the editor's document without a window. */
package lightning.document;
