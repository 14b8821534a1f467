/**
 * The program that made the pictures in {@code textures/}: every texture a function of the unit square that meets itself
 * at its borders, from noise of its own, without any input. See {@link lightning.textures.TextureGenerator} for how to run it.
 */
package lightning.textures;
