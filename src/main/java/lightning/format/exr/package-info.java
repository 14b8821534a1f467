/** OpenEXR files: images as named channels of numbers. */
package lightning.format.exr;
