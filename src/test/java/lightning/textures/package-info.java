/**
 * Procedural generator of the images in {@code textures/}: every texture is a seamless function of the unit square, built from noise
 * without any input. See {@link lightning.textures.TextureGenerator} to run it.
 */
package lightning.textures;
