/** Tests of what fog transmits and of the places of its samples. */
package lightning.render.fog;
