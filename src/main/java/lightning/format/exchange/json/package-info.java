/** Attributes that other formats lack, as JSON inside their files. */
package lightning.format.exchange.json;
