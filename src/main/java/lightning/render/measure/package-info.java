/** Measurements of cost and exactness of pictures: verification against a full trace, guarantees, savings, and what accuracy and effects cost. */
package lightning.render.measure;
