/** The editor without its window. */
package lightning.edit;
