/** NFF files, and the standard databases that they were made for. */
package lightning.format.nff;
