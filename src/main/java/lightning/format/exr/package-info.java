/** Files of OpenEXR: a picture as columns of numbers, each with a name. */
package lightning.format.exr;
