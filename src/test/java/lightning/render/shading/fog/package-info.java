/** Tests of light in fog. */
package lightning.render.shading.fog;
