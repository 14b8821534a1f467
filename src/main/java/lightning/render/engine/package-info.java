/**
 * The seam between what is computed of a tile and how: {@link lightning.render.engine.Engine}. Each package below it is one way.
 */
package lightning.render.engine;
