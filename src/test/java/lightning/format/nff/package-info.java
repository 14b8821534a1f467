/** NFF files, and the standard databases that use them. */
package lightning.format.nff;
