/** Layers (AOVs) of an image that add up to it, written as one OpenEXR file. */
package lightning.format.layer;
