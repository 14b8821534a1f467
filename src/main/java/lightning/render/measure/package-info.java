/** What a picture costs and how exact it is: verification against a full trace, guarantees, savings, and what accuracy and effects cost. */
package lightning.render.measure;
