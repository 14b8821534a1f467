/** A picture taken apart into layers that add up to it, and written as one file of OpenEXR. */
package lightning.format.layer;
